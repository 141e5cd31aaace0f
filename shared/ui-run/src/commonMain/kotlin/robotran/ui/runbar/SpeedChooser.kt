package robotran.ui.runbar

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.unit.dp
import robotran.runcontrol.RunSpeed
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*

/** Shows the speed as a symbol and changes it; as wide as the widest symbol. */
@Composable
internal fun SpeedChooser(speed: RunSpeed, onSpeed: (RunSpeed) -> Unit, modifier: Modifier = Modifier) {
    var open by remember { mutableStateOf(false) }
    val name = RunTexts.speed(spoken)
    val word = speed.word(spoken)
    Box(modifier) {
        ButtonFrame(
            RunTags.SPEED,
            ButtonKind.TOOL,
            Modifier.semantics {
                contentDescription = name
                stateDescription = word
            },
            onClick = { open = true },
        ) {
            SteadySize(speed, RunSpeed.entries) {
                Text(it.sign, style = TextStyles.body, maxLines = 1)
            }
            IconView(RunIcons.UP, LocalRobotranColours.current.onPane, Modifier.padding(start = 4.dp), size = 16.dp)
        }
        AppMenu(open, { open = false }) {
            SpeedChoices(speed) {
                open = false
                onSpeed(it)
            }
        }
    }
}

/** All speeds, slowest first. */
@Composable
internal fun SpeedChoices(speed: RunSpeed, onSpeed: (RunSpeed) -> Unit) {
    for (choice in RunSpeed.entries) {
        MenuItem(
            choice.word(spoken),
            RunTags.speed(choice),
            Modifier.semantics { selected = choice == speed },
            { RadioMark(choice == speed) },
        ) { onSpeed(choice) }
    }
}

/** The symbol of the speed, as on media players. */
private val RunSpeed.sign: String
    get() = when (this) {
        RunSpeed.TENTH -> "1/10×"
        RunSpeed.QUARTER -> "1/4×"
        RunSpeed.HALF -> "1/2×"
        RunSpeed.REAL_TIME -> "1×"
        RunSpeed.DOUBLE -> "2×"
        RunSpeed.FIVEFOLD -> "5×"
        RunSpeed.TENFOLD -> "10×"
        RunSpeed.FASTEST -> "»"
    }

/** The speed in one or two words. */
internal val RunSpeed.word: Label
    get() = when (this) {
        RunSpeed.TENTH -> RunTexts::speedTenth
        RunSpeed.QUARTER -> RunTexts::speedQuarter
        RunSpeed.HALF -> RunTexts::speedHalf
        RunSpeed.REAL_TIME -> RunTexts::speedReal
        RunSpeed.DOUBLE -> RunTexts::speedDouble
        RunSpeed.FIVEFOLD -> RunTexts::speedFivefold
        RunSpeed.TENFOLD -> RunTexts::speedTenfold
        RunSpeed.FASTEST -> RunTexts::speedFastest
    }
