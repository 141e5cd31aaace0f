package robotran.ui.common

import androidx.compose.runtime.Composable
import robotran.ui.texts.CommonTexts
import robotran.uikit.*

/** The numbers of one to three [ports], as in `1, 2 and 3`. */
@Composable
fun portNumbers(ports: List<Int>): String = when (ports.size) {
    1 -> "${ports.single()}"
    2 -> CommonTexts.portsTwo(spoken, ports[0], ports[1])
    else -> CommonTexts.portsThree(spoken, ports[0], ports[1], ports[2])
}
