package robotran.worldediting

import robotran.editing.Field
import robotran.editing.NumberSpec
import robotran.editing.Option
import robotran.editing.Words
import robotran.editing.WorldEditorTexts
import robotran.language.Language
import robotran.world.WorldLimits
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape

/** The place and the size of an element as numbers. */
internal fun WorldEditing.formFields(ref: ElementRef, element: Element): List<Field<WorldEdit>> {
    val change = { form: Form -> WorldEdit.Change(ref, element.withForm(form)) }
    return when (val form = element.form) {
        is Form.Area -> shapeFields(ref, form.shape) { change(Form.Area(it)) }
        is Form.Way -> listOf(cornerFields(ref, form.corners, canGrow = form.isBent))

        is Form.Start -> with(form.pose) {
            placeFields(Point(x, y)) { change(form.copy(pose = Pose(it.x, it.y, heading))) } +
                angleField(WorldEditorTexts::heading, heading, turnStep) {
                    change(form.copy(pose = copy(heading = it)))
                }
        }

        is Form.Light -> placeFields(form.place) { change(form.copy(place = it)) }
        is Form.Picture -> placeFields(form.corner) { change(form.copy(corner = it)) }
        null -> emptyList()
    }
}

private fun WorldEditing.shapeFields(
    ref: ElementRef,
    shape: Shape,
    change: (Shape) -> WorldEdit,
): List<Field<WorldEdit>> = when (shape) {
    is Shape.Rectangle -> with(shape) {
        placeFields(centre) { change(copy(centre = it)) } +
            Field.Number("field-width", WorldEditorTexts::width, width, SIZE) { change(copy(width = it)) } +
            Field.Number("field-height", WorldEditorTexts::height, height, SIZE) { change(copy(height = it)) } +
            angleField(WorldEditorTexts::angle, angle, turnStep) { change(copy(angle = it)) } +
            makeCorners(ref)
    }

    is Shape.Circle -> placeFields(shape.centre) { change(shape.copy(centre = it)) } +
        Field.Number("field-radius", WorldEditorTexts::radius, shape.radius, SIZE) { change(shape.copy(radius = it)) } +
        makeCorners(ref)

    is Shape.Polygon -> listOf(cornerFields(ref, shape.corners, canGrow = true))
}

private fun makeCorners(ref: ElementRef): Field<WorldEdit> =
    Field.Buttons(listOf(Option(WorldEdit.MakeCorners(ref), WorldEditorTexts::makeCorners, "make-corners")))

private fun placeFields(point: Point, tag: String = "field-", with: (Point) -> WorldEdit): List<Field<WorldEdit>> =
    listOf(
        Field.Number("${tag}x", WorldEditorTexts::x, point.x, COORDINATE) { with(point.copy(x = it)) },
        Field.Number("${tag}y", WorldEditorTexts::y, point.y, COORDINATE) { with(point.copy(y = it)) },
    )

internal fun <T : Any> angleField(label: Words, value: Double, step: Double, with: (Double) -> T): Field<T> =
    Field.Number(
        "field-angle",
        label,
        value,
        NumberSpec(ANGLES, step = step, unit = "°", slider = -180.0..180.0),
        with,
    )

private fun cornerFields(ref: ElementRef, corners: List<Point>, canGrow: Boolean): Field<WorldEdit> {
    val names = corners.indices.map { number ->
        { language: Language -> WorldEditorTexts.corner(language, number + 1) }
    }
    return Field.OneOf("corner", { WorldEditorTexts.corners(it, corners.size) }, names) { number ->
        val place = placeFields(corners[number], "field-corner-") { WorldEdit.MoveCorner(ref, number, it) }
        val after = if (number < corners.lastIndex) number else (number - 1).coerceAtLeast(0)
        val buttons = listOf(
            Option(WorldEdit.AddCorner(ref, after), WorldEditorTexts::addCorner, "add-corner"),
            Option(WorldEdit.RemoveCorner(ref, number), WorldEditorTexts::removeCorner, "remove-corner"),
        )
        if (canGrow) place + Field.Buttons(buttons) else place
    }
}

/** By how many degrees a button or a key turns. */
val WorldEditing.turnStep: Double get() = if (snapping.angle > 0) snapping.angle else 1.0

private val COORDINATE = NumberSpec(WorldLimits.MINIMUM_COORDINATE..WorldLimits.MAXIMUM_COORDINATE, unit = "cm")
private val SIZE = NumberSpec(WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_SHAPE_SIDE, unit = "cm")
private val ANGLES = -WorldLimits.MAXIMUM_ANGLE..WorldLimits.MAXIMUM_ANGLE
