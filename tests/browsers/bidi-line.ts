// WebDriver BiDi over a socket. In: an address and commands. Out: their answers.
interface Answer {
  readonly id?: number;
  readonly result?: unknown;
  readonly error?: string;
  readonly message?: string;
}

export class BidiLine {
  private readonly waiting = new Map<number, (answer: Answer) => void>();
  private last = 0;

  private constructor(private readonly socket: WebSocket) {
    socket.addEventListener('message', ({ data }) => {
      const answer = JSON.parse(String(data)) as Answer;
      this.waiting.get(answer.id ?? 0)?.(answer);
      this.waiting.delete(answer.id ?? 0);
    });
    socket.addEventListener('close', () => {
      for (const hear of this.waiting.values()) hear({ error: 'the browser is gone' });
    });
  }

  static async to(address: string): Promise<BidiLine> {
    const socket = new WebSocket(address);
    await new Promise((resolve, reject) => {
      socket.addEventListener('open', resolve);
      socket.addEventListener('error', () => reject(new Error(`no answer from ${address}`)));
    });
    return new BidiLine(socket);
  }

  send<T>(method: string, params: object): Promise<T> {
    const id = ++this.last;
    this.socket.send(JSON.stringify({ id, method, params }));
    return new Promise((resolve, reject) => {
      this.waiting.set(id, ({ result, error, message }) => {
        if (error === undefined) resolve(result as T);
        else reject(new Error(`${method}: ${error} ${message ?? ''}`));
      });
    });
  }
}
