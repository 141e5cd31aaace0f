package robotran.worldediting

import robotran.brick.sensors.SensorKind
import robotran.editing.Field
import robotran.editing.NumberSpec
import robotran.editing.TextSpec
import robotran.editing.Words
import robotran.editing.WorldEditorTexts
import robotran.editing.making
import robotran.world.HasActor
import robotran.world.HasLine
import robotran.world.HasRegion
import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.WorldLimits

/**
 * All fields of one element in display order.
 *
 * @param pluggedWords says what is on a port of a robot, by what the port is called on the brick.
 */
fun WorldEditing.fieldsOf(ref: ElementRef, pluggedWords: (String, SensorKind?) -> Words): List<Field<WorldEdit>> {
    val element = world.piece(ref) ?: return emptyList()
    val own = ownFields(element, turnStep).making { WorldEdit.Change(ref, it) }
    return when (element) {
        is Element.OfRobot -> robotFields(ref, element, pluggedWords)
        is Element.OfGoal -> goalFields(ref, element)
        is Element.OfWall -> formFields(ref, element) + own
        is Element.OfStroke -> formFields(ref, element)

        is Element.OfBarrier, is Element.OfBlock, is Element.OfMark, is Element.OfLamp -> {
            listOf(nameField(ref, element)) + own + formFields(ref, element)
        }
    }
}

/** A name is needed only if a goal refers to the element. */
internal fun WorldEditing.nameField(ref: ElementRef, element: Element): Field<WorldEdit> = Field.Text(
    "field-name",
    WorldEditorTexts::name,
    element.name.orEmpty(),
    TextSpec(WorldLimits.MAXIMUM_NAME_CHARACTERS, mayBeBlank = element !is Element.OfRobot),
    WorldEditorTexts::noName,
    isRefused = error is WorldEditError.NameTaken,
) { WorldEdit.Change(ref, element.named(it.takeIf(String::isNotBlank))) }

/** The fields of [element] besides its name, its place and its size. */
internal fun ownFields(element: Element, turnStep: Double = 1.0): List<Field<Element>> = when (element) {
    is Element.OfWall -> with(element.wall) {
        listOf(thicknessField(thickness) { Element.OfWall(copy(thickness = it)) })
    }

    is Element.OfBlock -> with(element.block) {
        listOf(
            Field.Number("field-mass", WorldEditorTexts::mass, mass, MASS) { Element.OfBlock(copy(mass = it)) },
            Field.Number("field-friction", WorldEditorTexts::friction, friction, FRICTION) {
                Element.OfBlock(copy(friction = it))
            },
            Field.Help(WorldEditorTexts::frictionHelp),
        )
    }

    is Element.OfMark -> markFields(element.mark).making { Element.OfMark(it) }
    is Element.OfLamp -> lampFields(element.lamp, turnStep).making { Element.OfLamp(it) }
    is Element.OfRobot, is Element.OfBarrier, is Element.OfStroke, is Element.OfGoal -> emptyList()
}

private fun markFields(mark: Mark): List<Field<Mark>> {
    val shade = shadeField(mark.shade).map { mark.copy(shade = it) }
    return when (val figure = mark.figure) {
        is MarkFigure.GreyMap -> listOf(Field.Help(WorldEditorTexts::greyMapHelp))
        is MarkFigure.Area -> listOf(shade)

        is MarkFigure.Line -> listOf(
            shade,
            thicknessField(figure.width) { mark.copy(figure = figure.copy(width = it)) },
            Field.Flag("field-closed", WorldEditorTexts::closed, figure.closed) {
                mark.copy(figure = figure.copy(closed = it))
            },
        )
    }
}

private fun <T : Any> thicknessField(value: Double, with: (Double) -> T): Field<T> =
    Field.Number("field-thickness", WorldEditorTexts::thickness, value, THICKNESS, with)

private fun lampFields(lamp: Lamp, turnStep: Double): List<Field<Lamp>> = with(lamp) {
    listOf(
        Field.Flag("field-on", WorldEditorTexts::lampOn, on) { copy(on = it) },
        Field.Flag("field-infrared", WorldEditorTexts::lampInfrared, infrared) { copy(infrared = it) },
        Field.Number("field-brightness", WorldEditorTexts::brightness, brightness, BRIGHTNESS) {
            copy(brightness = it)
        },
        Field.Number("field-cone", WorldEditorTexts::cone, cone, CONE) { copy(cone = it) },
        if (cone < Lamp.ALL_ROUND) {
            angleField(WorldEditorTexts::direction, direction, turnStep) { copy(direction = it) }
        } else {
            Field.Help(WorldEditorTexts::coneHelp)
        },
    )
}

private fun WorldEditing.goalFields(ref: ElementRef, element: Element.OfGoal): List<Field<WorldEdit>> {
    val goal = element.goal
    val condition = goal.condition
    val says = Field.Text(
        "field-says",
        WorldEditorTexts::says,
        goal.says.orEmpty(),
        TextSpec(WorldLimits.MAXIMUM_SENTENCE_CHARACTERS, mayBeBlank = true),
        WorldEditorTexts::saysHint,
    ) { WorldEdit.Change(ref, Element.OfGoal(goal.copy(says = it.takeIf(String::isNotBlank)))) }
    val fields = listOfNotNull((condition as? HasLine)?.let { lineField(ref, goal, it) }) +
        fieldsOf(condition, world.timeLimit)
            .making { WorldEdit.Change(ref, Element.OfGoal(goal.copy(condition = it))) }
    return listOfNotNull(
        says,
        if (fields.isEmpty()) null else Field.Group(fields),
        Field.Help(WorldEditorTexts::groupHelp).takeIf { goal.isGroup },
        (condition as? HasActor)?.let { whoField(ref, goal, it) },
    ) + if (condition is HasRegion) formFields(ref, element) else emptyList()
}

private val MASS =
    NumberSpec(WorldLimits.MINIMUM_MASS..WorldLimits.MAXIMUM_MASS, step = 0.05, unit = "kg", slider = 0.05..2.0)
private val FRICTION = NumberSpec(0.0..WorldLimits.MAXIMUM_FRICTION, step = 0.05, slider = 0.0..1.5)
private val THICKNESSES = WorldLimits.MINIMUM_THICKNESS..WorldLimits.MAXIMUM_WALL_THICKNESS
private val THICKNESS = NumberSpec(THICKNESSES, step = 0.5, unit = "cm", slider = 0.5..10.0)
private val BRIGHTNESS = NumberSpec(0.0..WorldLimits.MAXIMUM_BRIGHTNESS, step = 0.5, slider = 0.0..10.0)
private val CONE = NumberSpec(WorldLimits.MINIMUM_CONE..Lamp.ALL_ROUND, step = 15.0, unit = "°", slider = 15.0..360.0)
