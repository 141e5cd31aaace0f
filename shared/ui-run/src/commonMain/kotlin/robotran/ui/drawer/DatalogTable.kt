package robotran.ui.drawer

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import robotran.legofirmware.device.DatalogEntry
import robotran.ui.run.tags.RunTags
import robotran.ui.texts.NqcTexts
import robotran.uikit.*
import robotran.workshop.run.origin

/** The last values in the datalog of LEGO's firmware, and a button that saves all as a table. Empty without values. */
@Composable
internal fun DatalogTable(
    datalog: List<DatalogEntry>,
    variables: Map<Int, String>,
    onSave: () -> Unit,
    modifier: Modifier,
) {
    if (datalog.isEmpty()) return
    val colours = LocalRobotranColours.current
    val left = maxOf(0, datalog.size - SHOWN)
    Column(modifier.padding(12.dp).testTag(RunTags.DATALOG)) {
        Row(
            Modifier.fillMaxWidth(),
            horizontalArrangement = Arrangement.SpaceBetween,
            verticalAlignment = Alignment.CenterVertically,
        ) {
            Text(
                NqcTexts.runDatalog(spoken),
                Modifier.weight(1f).heading(),
                TextStyles.small.medium,
                color = colours.quiet,
            )
            Button(NqcTexts.runDatalogSave(spoken), RunTags.DATALOG_SAVE, ButtonKind.SMALL_LINK, onClick = onSave)
        }
        Column(Modifier.widthIn(max = MAX_WIDTH)) {
            val head = codeStyle(colours.quiet).copy(fontFamily = FontFamily.Default, fontSize = TextSizes.SMALL)
            Cells(
                NqcTexts.runDatalogNumber(spoken),
                NqcTexts.runDatalogSource(spoken),
                NqcTexts.runDatalogValue(spoken),
                head,
                Modifier.clearAndSetSemantics { },
            )
            if (left > 0) {
                Text(
                    NqcTexts.runDatalogMore(spoken, left),
                    Modifier.padding(vertical = 4.dp),
                    TextStyles.small,
                    color = colours.quiet,
                )
            }
            for (index in left until datalog.size) Entry(index + 1, datalog[index], variables)
        }
    }
}

@Composable
private fun Entry(number: Int, entry: DatalogEntry, variables: Map<Int, String>) {
    val origin = entry.origin(variables)
    val words = NqcTexts.runDatalogEntry(spoken, number, origin, entry.value)
    val read = Modifier.testTag(RunTags.datalog(number)).clearAndSetSemantics { contentDescription = words }
    Cells("$number", origin, "${entry.value}", codeStyle(), read)
}

@Composable
private fun Cells(number: String, source: String, value: String, style: TextStyle, modifier: Modifier) {
    Row(modifier.fillMaxWidth().padding(vertical = 2.dp), Arrangement.spacedBy(12.dp)) {
        val right = style.copy(textAlign = TextAlign.End)
        Text(number, Modifier.weight(1f), right, maxLines = 1)
        Text(source, Modifier.weight(2f), style, maxLines = 1)
        Text(value, Modifier.weight(1f), right, maxLines = 1)
    }
}

/** More would make the drawer slow; the saved table has all. */
private const val SHOWN = 100
private val MAX_WIDTH = 420.dp
