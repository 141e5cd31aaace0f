package robotran.cli.console

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import robotran.cli.messages.CommandMessages
import robotran.language.Language
import robotran.language.listed

/**
 * The language of a command's messages. The system locale is ignored, so scripts get the same output everywhere unless
 * they set the language.
 */
internal class LanguageOption : OptionGroup() {
    val language by option(
        "--language",
        metavar = Language.entries.joinToString("|") { it.tag },
        envvar = "ROBOTRAN_LANGUAGE",
        help = "tells mistakes and results in $NAMES; English if neither this nor ROBOTRAN_LANGUAGE is given",
    ).convert { text -> Language.of(text) ?: fail("$text is none of ${Language.entries.joinToString { it.tag }}") }
        .default(Language.ENGLISH)

    private companion object {
        /** In English, as all help is. */
        val NAMES = listed(Language.entries.map { it.name.lowercase().replaceFirstChar(Char::uppercase) }, "or")
    }
}

/** This console with messages in [language]. */
internal fun Console.speaking(language: Language): Console = SpeakingConsole(this, language)

/** The messages in this console's language. */
internal val Console.messages: CommandMessages get() = CommandMessages.of(language)

private class SpeakingConsole(private val console: Console, override val language: Language) : Console by console
