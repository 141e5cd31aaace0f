package robotran.languagesupport

/** The text of a program as an editor has read it. Only its language knows more of it. */
interface ParsedSource
