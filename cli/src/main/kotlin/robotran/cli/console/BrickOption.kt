package robotran.cli.console

import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.parameters.options.NullableOption
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.option
import robotran.brick.kind.BrickKind

private val BRICKS = BrickKind.entries.associateBy { it.word }

/** `--brick`: the brick that programs are for; null if not given. */
internal fun ParameterHolder.brickOption(): NullableOption<BrickKind, BrickKind> = option(
    "--brick",
    metavar = BRICKS.keys.joinToString("|"),
    help = "the brick that the programs are for; if not given, what they say themselves, otherwise an RCX",
).convert { text -> BRICKS[text.lowercase()] ?: fail("$text is none of ${BRICKS.keys.joinToString()}") }
