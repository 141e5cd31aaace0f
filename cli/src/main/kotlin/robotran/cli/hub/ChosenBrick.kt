package robotran.cli.hub

import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.parameters.options.NullableOption
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.option
import robotran.brick.kind.BrickKind
import robotran.robolang.python.PybricksHub

/** What programs are for: a [brick] that can be simulated, or a [hub] that runs Pybricks. */
internal class ChosenBrick private constructor(val brick: BrickKind?, val hub: PybricksHub?) {
    companion object {
        private val BRICKS = BrickKind.entries.associateBy { it.name.lowercase() }

        /** What can be chosen, as it is typed. */
        val words: List<String> = BRICKS.keys.toList() + PybricksHub.entries.map { it.word }

        fun of(word: String): ChosenBrick? {
            val brick = BRICKS[word]
            val hub = PybricksHub.of(word)
            return if (brick == null && hub == null) null else ChosenBrick(brick, hub)
        }
    }
}

/** `--brick` of a command that also takes programs to hubs; null if not given. */
internal fun ParameterHolder.chosenBrickOption(): NullableOption<ChosenBrick, ChosenBrick> = option(
    "--brick",
    metavar = ChosenBrick.words.joinToString("|"),
    help = "the brick that the programs are for, or the hub with Pybricks; if not given, what they say themselves, " +
        "otherwise an RCX",
).convert { text ->
    ChosenBrick.of(text.lowercase()) ?: fail("$text is none of ${ChosenBrick.words.joinToString()}")
}

/** `--brick` of a command that otherwise is for an RCX; null if not given. */
internal fun ParameterHolder.hubOption(): NullableOption<PybricksHub, PybricksHub> = option(
    "--brick",
    metavar = HUBS.joinToString("|"),
    help = "the hub with Pybricks that a program in Robolang is for; an RCX if not given",
).convert { text -> PybricksHub.of(text.lowercase()) ?: fail("$text is none of ${HUBS.joinToString()}") }

private val HUBS = PybricksHub.entries.map { it.word }
