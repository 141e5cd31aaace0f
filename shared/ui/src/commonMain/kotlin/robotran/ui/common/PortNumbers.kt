package robotran.ui.common

import androidx.compose.runtime.Composable
import robotran.ui.texts.RunTexts
import robotran.uikit.*

/** The numbers of one to three [ports], as in `1, 2 and 3`. */
@Composable
internal fun portNumbers(ports: List<Int>): String = when (ports.size) {
    1 -> "${ports.single()}"
    2 -> RunTexts.portsTwo(spoken, ports[0], ports[1])
    else -> RunTexts.portsThree(spoken, ports[0], ports[1], ports[2])
}
