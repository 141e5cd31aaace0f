package robotran.ui.worldedit

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.world.WorldLimits
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.worldediting.Element
import robotran.worldediting.ElementRef
import robotran.worldediting.Form
import robotran.worldediting.WorldEdit
import robotran.worldediting.corners
import robotran.worldediting.form
import robotran.worldediting.withForm

/** The place and the size of an element as numbers. */
@Composable
internal fun FormFields(editor: EditorScope, ref: ElementRef, element: Element) {
    val change = { form: Form -> editor.change(ref, element.withForm(form)) }
    when (val form = element.form) {
        is Form.Area -> ShapeFields(editor, ref, form.shape) { change(Form.Area(it)) }
        is Form.Way -> CornerFields(editor, ref, form.corners, canGrow = form.isBent)

        is Form.Start -> {
            PlaceFields(editor, Point(form.pose.x, form.pose.y)) {
                change(form.copy(pose = Pose(it.x, it.y, form.pose.heading)))
            }
            AngleField(editor, WorldEditorTexts.heading(spoken), form.pose.heading) {
                change(form.copy(pose = form.pose.copy(heading = it)))
            }
        }

        is Form.Light -> PlaceFields(editor, form.place) { change(form.copy(place = it)) }
        is Form.Picture -> PlaceFields(editor, form.corner) { change(form.copy(corner = it)) }
        null -> {}
    }
}

@Composable
private fun ShapeFields(editor: EditorScope, ref: ElementRef, shape: Shape, onChange: (Shape) -> Unit) {
    when (shape) {
        is Shape.Rectangle -> {
            PlaceFields(editor, shape.centre) { onChange(shape.copy(centre = it)) }
            SizeField(editor, WorldEditorTexts.width(spoken), shape.width, "width") {
                onChange(shape.copy(width = it))
            }
            SizeField(editor, WorldEditorTexts.height(spoken), shape.height, "height") {
                onChange(shape.copy(height = it))
            }
            AngleField(editor, WorldEditorTexts.angle(spoken), shape.angle) {
                onChange(shape.copy(angle = it))
            }
            MakeCorners(editor, ref)
        }

        is Shape.Circle -> {
            PlaceFields(editor, shape.centre) { onChange(shape.copy(centre = it)) }
            SizeField(editor, WorldEditorTexts.radius(spoken), shape.radius, "radius") {
                onChange(shape.copy(radius = it))
            }
            MakeCorners(editor, ref)
        }

        is Shape.Polygon -> CornerFields(editor, ref, shape.corners, canGrow = true)
    }
}

@Composable
private fun MakeCorners(editor: EditorScope, ref: ElementRef) = WordButton(
    WorldEditorTexts.makeCorners(spoken),
    "make-corners",
    { editor.make(WorldEdit.MakeCorners(ref)) },
    Modifier.padding(top = 8.dp),
)

@Composable
internal fun PlaceFields(editor: EditorScope, point: Point, tag: String = "", onChange: (Point) -> Unit) {
    CoordinateField(editor, WorldEditorTexts.x(spoken), point.x, "${tag}x") { onChange(point.copy(x = it)) }
    CoordinateField(editor, WorldEditorTexts.y(spoken), point.y, "${tag}y") { onChange(point.copy(y = it)) }
}

@Composable
private fun CoordinateField(
    editor: EditorScope,
    title: String,
    value: Double,
    tag: String,
    onChange: (Double) -> Unit,
) = NumberRow(
    title,
    value,
    WorldLimits.MINIMUM_COORDINATE..WorldLimits.MAXIMUM_COORDINATE,
    "field-$tag",
    onChange,
    editor::settle,
    unit = "cm",
)

@Composable
private fun SizeField(editor: EditorScope, title: String, value: Double, tag: String, onChange: (Double) -> Unit) =
    NumberRow(
        title,
        value,
        WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_SHAPE_SIDE,
        "field-$tag",
        onChange,
        editor::settle,
        unit = "cm",
    )

@Composable
internal fun AngleField(editor: EditorScope, title: String, value: Double, onChange: (Double) -> Unit) = NumberRow(
    title,
    value,
    -WorldLimits.MAXIMUM_ANGLE..WorldLimits.MAXIMUM_ANGLE,
    "field-angle",
    onChange,
    editor::settle,
    step = turnStep(editor.editing),
    unit = "°",
    slider = -180f..180f,
)

/** The corners one by one, since a list of all would be long. */
@Composable
private fun CornerFields(editor: EditorScope, ref: ElementRef, corners: List<Point>, canGrow: Boolean) {
    var chosen by remember(ref) { mutableIntStateOf(0) }
    val number = chosen.coerceIn(corners.indices)
    Column(Modifier.fillMaxWidth()) {
        val words = corners.indices.map { it to WorldEditorTexts.corner(spoken, it + 1) }
        MenuRow(WorldEditorTexts.corners(spoken, corners.size), words, words[number].second, "corner") {
            chosen = it
        }
        PlaceFields(editor, corners[number], "corner-") { editor.make(WorldEdit.MoveCorner(ref, number, it)) }
        if (!canGrow) return@Column
        Row(Modifier.padding(top = 4.dp), Arrangement.spacedBy(8.dp)) {
            WordButton(WorldEditorTexts.addCorner(spoken), "add-corner", {
                val after = if (number < corners.lastIndex) number else (number - 1).coerceAtLeast(0)
                editor.make(WorldEdit.AddCorner(ref, after))
            }, Modifier.weight(1f))
            WordButton(WorldEditorTexts.removeCorner(spoken), "remove-corner", {
                editor.make(WorldEdit.RemoveCorner(ref, number))
            }, Modifier.weight(1f))
        }
    }
}
