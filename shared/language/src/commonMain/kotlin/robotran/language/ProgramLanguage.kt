package robotran.language

/**
 * The languages that pupils program in.
 *
 * @property extension what the names of its files end with.
 */
enum class ProgramLanguage(val extension: String) { ROBOLANG(".robo"), JAVA(".java") }
