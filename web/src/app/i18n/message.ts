/** A sentence as a language has it: one form, or two that go by its first number. */
export type Message = string | { readonly one: string; readonly other: string };
