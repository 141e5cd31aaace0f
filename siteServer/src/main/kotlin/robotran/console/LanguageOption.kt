package robotran.console

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import robotran.language.Language
import robotran.language.listed

/**
 * The language of a command's messages. The system locale is ignored, so scripts get the same output everywhere unless
 * they set the language.
 */
class LanguageOption : OptionGroup() {
    val language by option(
        OPTION,
        metavar = Language.entries.joinToString("|") { it.tag },
        envvar = VARIABLE,
        help = "tells mistakes and results in $NAMES; English if neither this nor $VARIABLE is given",
    ).convert { text -> Language.of(text) ?: fail("$text is none of ${Language.entries.joinToString { it.tag }}") }
        .default(Language.ENGLISH)

    private companion object {
        /** In English, as all help is. */
        val NAMES = listed(Language.entries.map { it.name.lowercase().replaceFirstChar(Char::uppercase) }, "or")
    }
}

/** The language that [arguments] ask for, where they may be wrong in other things. */
fun languageIn(arguments: List<String>): Language {
    val named = arguments.zipWithNext().firstOrNull { it.first == OPTION }?.second
        ?: arguments.firstOrNull { it.startsWith("$OPTION=") }?.substringAfter('=')
    return Language.of(named ?: System.getenv(VARIABLE).orEmpty()) ?: Language.ENGLISH
}

private const val OPTION = "--language"
private const val VARIABLE = "ROBOTRAN_LANGUAGE"

/** This console with messages in [language]. */
fun Console.speaking(language: Language): Console = SpeakingConsole(this, language)

private class SpeakingConsole(private val console: Console, override val language: Language) : Console by console
