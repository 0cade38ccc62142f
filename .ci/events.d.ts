// A listener knows which kind of element its event is about.
interface Window {
  addEventListener(type: string, listener: (event: any) => void, options?: object | boolean): void;
}
declare function addEventListener(
  type: string, listener: (event: any) => void, options?: object | boolean,
): void;
