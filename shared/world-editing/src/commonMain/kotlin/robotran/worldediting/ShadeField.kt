package robotran.worldediting

import robotran.editing.Field
import robotran.editing.NumberSpec
import robotran.editing.Option
import robotran.editing.Words
import robotran.editing.WorldEditorTexts
import robotran.editing.swatches
import robotran.world.Shade
import kotlin.math.roundToInt

/** The colour of a mark: a swatch, any grey, or any colour as numbers, and its brightness for the robot's sensor. */
internal fun shadeField(shade: Shade): Field<Shade> {
    val numbers = when (shade) {
        is Shade.Grey -> listOf(
            Field.Number("field-grey", WorldEditorTexts::grey, shade.reflectance, GREY) { Shade.Grey(it) },
        )

        is Shade.Colour -> listOf(
            partField("red", WorldEditorTexts::redPart, shade.red) { shade.copy(red = it) },
            partField("green", WorldEditorTexts::greenPart, shade.green) { shade.copy(green = it) },
            partField("blue", WorldEditorTexts::bluePart, shade.blue) { shade.copy(blue = it) },
        )
    }
    val percent = (shade.reflectance * PERCENT).roundToInt()
    return Field.Group(
        listOf(swatches("shade", WorldEditorTexts::shade, SHADES, shade) { it }) + numbers +
            Field.Help { WorldEditorTexts.seenBySensor(it, percent) },
    )
}

private fun partField(name: String, label: Words, value: Int, with: (Int) -> Shade): Field<Shade> =
    Field.Number("field-$name", label, value.toDouble(), PART) { with(it.toInt()) }

private val SHADES: List<Option<Shade>> = listOf(
    Option(Shade.Grey(0.0), WorldEditorTexts::black),
    Option(Shade.Grey(0.3), WorldEditorTexts::darkGrey),
    Option(Shade.Grey(0.6), WorldEditorTexts::lightGrey),
    Option(Shade.Grey(1.0), WorldEditorTexts::white),
    Option(Shade.Colour(200, 40, 30), WorldEditorTexts::red),
    Option(Shade.Colour(235, 130, 20), WorldEditorTexts::orange),
    Option(Shade.Colour(245, 205, 30), WorldEditorTexts::yellow),
    Option(Shade.Colour(40, 150, 70), WorldEditorTexts::green),
    Option(Shade.Colour(17, 51, 170), WorldEditorTexts::blue),
    Option(Shade.Colour(120, 60, 160), WorldEditorTexts::purple),
)
private const val PERCENT = 100
private val GREY = NumberSpec(0.0..1.0, step = 0.05, slider = 0.0..1.0)
private val PART = NumberSpec(0..255, step = 5.0, slider = 0.0..255.0)
