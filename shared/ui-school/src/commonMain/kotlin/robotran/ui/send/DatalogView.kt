package robotran.ui.send

import androidx.compose.foundation.layout.Column
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import robotran.legofirmware.device.DatalogEntry
import robotran.legofirmware.device.DatalogSource
import robotran.legofirmware.device.source
import robotran.legofirmware.device.sourceNumber
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.SendTexts
import robotran.uikit.*

/** The first entries of a datalog, a line each. The saved table has all. */
@Composable
internal fun DatalogView(entries: List<DatalogEntry>) = Column(Modifier.testTag(SendTags.SEND_DATALOG)) {
    entries.take(SHOWN).forEachIndexed { index, entry ->
        val words = when (entry.source) {
            DatalogSource.VARIABLE -> SendTexts::datalogVariable
            DatalogSource.TIMER -> SendTexts::datalogTimer
            DatalogSource.SENSOR -> SendTexts::datalogSensor
            DatalogSource.WATCH -> SendTexts::datalogWatch
            DatalogSource.OTHER -> SendTexts::datalogOther
        }
        Line(words(spoken, index + 1, entry.sourceNumber ?: 0, entry.value))
    }
    if (entries.size > SHOWN) Line(SendTexts.datalogMore(spoken, entries.size - SHOWN))
}

@Composable
private fun Line(label: String) = Text(label, style = TextStyles.body)

private const val SHOWN = 50
