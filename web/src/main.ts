// Where the app starts. In: the page of index.html. Out: the app in its #app.
const app = document.querySelector('#app');
if (app) app.textContent = 'Keypose';
