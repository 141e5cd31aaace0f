package robotran.ui.common

import androidx.compose.runtime.Composable
import robotran.ui.texts.CommonTexts
import robotran.uikit.*

/** The names of some [ports], as in `1, 2 and 3`. */
@Composable
fun portNames(ports: List<String>): String = when (ports.size) {
    1 -> ports.single()
    2 -> CommonTexts.portsTwo(spoken, ports[0], ports[1])
    else -> CommonTexts.portsThree(spoken, ports[0], ports[1], ports[2])
}
