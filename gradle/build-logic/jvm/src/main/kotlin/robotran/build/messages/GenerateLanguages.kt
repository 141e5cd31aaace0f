package robotran.build.messages

import org.gradle.api.DefaultTask
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction

/** Generates the enum of the languages of people from their table. */
@CacheableTask
abstract class GenerateLanguages : DefaultTask() {
    @get:InputFile
    @get:PathSensitive(PathSensitivity.NONE)
    abstract val languages: RegularFileProperty

    @get:OutputDirectory
    abstract val outputFolder: DirectoryProperty

    @TaskAction
    fun generate() {
        val file = languages.get().asFile
        outputFolder.get().asFile.resolve(
            "Language.kt",
        ).writeText(languageEnum(readLanguages(file.name, file.readText())))
    }
}

/** The Kotlin of the enum. */
fun languageEnum(languages: List<SpokenLanguage>): String = """
    |// Generated from the table of languages.
    |package robotran.language
    |
    |/**
    | * The languages of the user interface and its messages. Robolang has words in each, and no run depends on the
    | * language.
    | *
    | * @property tag the language tag as in BCP 47 and in the names of resource folders.
    | * @property ownName the language's name in the language itself.
    | * @property decimalSign in a measured number such as `1.5`.
    | * @property isRightToLeft whether it is read from right to left.
    | * @property groupSign between thousands in numbers of more than [ungroupedDigits] digits.
    | */
    |enum class Language(
    |    val tag: String,
    |    val ownName: String,
    |    val decimalSign: Char,
    |    internal val groupSign: String,
    |    internal val ungroupedDigits: Int,
    |    val isRightToLeft: Boolean,
    |) {
    |${languages.joinToString("\n") { "    " + entry(it) }}
    |    ;
    |
    |    companion object {
    |        /**
    |         * Returns the language of a locale such as `de`, `de-AT`, `es_MX.UTF-8` or `ES`; null if there is none or it is
    |         * not supported.
    |         */
    |        fun of(locale: String): Language? {
    |            val requestedTag = locale.takeWhile { it.isLetter() }.lowercase()
    |            return entries.firstOrNull { it.tag == requestedTag }
    |        }
    |    }
    |}
    |
    """.trimMargin()

private fun entry(language: SpokenLanguage): String = with(language) {
    "$constant(\"$tag\", \"${escaped(ownName)}\", '$decimalSign', \"$groupSign\", $ungroupedDigits, $isRightToLeft),"
}
