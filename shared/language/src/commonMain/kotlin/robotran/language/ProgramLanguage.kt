package robotran.language

/**
 * The languages that pupils program in.
 *
 * @property extension the extension of its file names.
 */
enum class ProgramLanguage(val extension: String) { ROBOLANG(".robo"), JAVA(".java") }
