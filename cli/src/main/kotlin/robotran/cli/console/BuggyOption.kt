package robotran.cli.console

import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.parameters.options.NullableOption
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.option
import robotran.brick.kind.BuggyKind

/** `--buggy`: what a micro:bit is plugged into; null if not given. */
internal fun ParameterHolder.buggyOption(): NullableOption<BuggyKind, BuggyKind> = option(
    "--buggy",
    metavar = BuggyKind.entries.joinToString("|") { it.word },
    help = "with --brick microbit or microbit-v1: the buggy that the board is plugged into; if not given, a Cutebot",
).convert { text ->
    BuggyKind.of(text.lowercase()) ?: fail("$text is none of ${BuggyKind.entries.joinToString { it.word }}")
}
