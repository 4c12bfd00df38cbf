/** Props or null in; a view made, changed or destroyed accordingly. */

/** A view that takes changes, kept only while there are props for it. */
export function keep<Props>(
  create: (props: Props) => { update(props: Props): void; destroy(): void },
): (props: Props | null) => void {
  let view: ReturnType<typeof create> | null = null;
  return (props) => {
    if (props === null) {
      view?.destroy();
      view = null;
    } else if (view) view.update(props);
    else view = create(props);
  };
}
