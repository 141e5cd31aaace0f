package robotran.workshop.state

/** This text with the editor's line ends. */
fun String.withPlainLineEnds(): String = if ('\r' in this) replace("\r\n", "\n").replace('\r', '\n') else this
