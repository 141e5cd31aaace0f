package robotran.ui.assignment

import androidx.compose.foundation.Image
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.layout.ContentScale
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.ExperimentalResourceApi
import org.jetbrains.compose.resources.decodeToImageBitmap
import robotran.assignments.doing.bytesToShow
import robotran.projects.Assignment
import robotran.projects.AssignmentPicture
import robotran.ui.learning.MarkedText
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*

/** The text of [assignment] in paragraphs, with its pictures where it mentions them. */
@Composable
internal fun AssignmentText(assignment: Assignment, modifier: Modifier = Modifier) {
    val parts = remember(assignment.text) { partsOf(assignment.text) }
    if (parts.isEmpty()) return
    Column(modifier.fillMaxWidth().testTag(AssignmentTags.ASSIGNMENT_TEXT), Arrangement.spacedBy(8.dp)) {
        for (part in parts) {
            when (part) {
                is TextPart.Paragraph -> MarkedText(part.text)
                is TextPart.Picture -> Picture(part, assignment.pictures.firstOrNull { it.name == part.name })
            }
        }
    }
}

/** A part of the text of an assignment. */
internal sealed interface TextPart {
    data class Paragraph(val text: String) : TextPart

    /** A line `![description](name)`. */
    data class Picture(val description: String, val name: String) : TextPart
}

/** Blank lines separate paragraphs. */
internal fun partsOf(text: String): List<TextPart> {
    val parts = mutableListOf<TextPart>()
    val paragraph = mutableListOf<String>()

    fun end() {
        if (paragraph.isNotEmpty()) parts += TextPart.Paragraph(paragraph.joinToString("\n"))
        paragraph.clear()
    }
    for (line in text.lines().map { it.trim() }) {
        val picture = PICTURE.matchEntire(line)
        if (line.isEmpty() || picture != null) end() else paragraph += line
        if (picture != null) parts += TextPart.Picture(picture.groupValues[1], picture.groupValues[2])
    }
    end()
    return parts
}

@Composable
private fun Picture(part: TextPart.Picture, picture: AssignmentPicture?) {
    val bitmap = remember(picture) { picture?.let(::bitmapOf) }
    if (bitmap == null) {
        Text(
            SchoolTexts.assignmentPictureBroken(spoken, part.description),
            Modifier.testTag(AssignmentTags.ASSIGNMENT_PICTURE_BROKEN),
            TextStyles.sentence,
            color = LocalRobotranColours.current.quiet,
        )
    } else {
        // A small picture is not enlarged beyond its pixels.
        Image(
            bitmap,
            part.description,
            Modifier
                .testTag(AssignmentTags.ASSIGNMENT_PICTURE)
                .widthIn(max = minOf(bitmap.width.dp, MAX_SIDE))
                .heightIn(max = MAX_SIDE)
                .border(1.dp, LocalRobotranColours.current.line),
            contentScale = ContentScale.Fit,
        )
    }
}

/** Null for a picture that cannot be read; what a decoder throws differs between platforms. */
@OptIn(ExperimentalResourceApi::class)
private fun bitmapOf(picture: AssignmentPicture): ImageBitmap? =
    picture.bytesToShow()?.let { bytes -> runCatching { bytes.decodeToImageBitmap() }.getOrNull() }

private val PICTURE = Regex("!\\[([^\\]]*)]\\(([^)]*)\\)")
private val MAX_SIDE = 280.dp
