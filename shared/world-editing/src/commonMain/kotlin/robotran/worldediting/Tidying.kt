package robotran.worldediting

import robotran.json.nearestDecimal
import robotran.world.Goal
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.Shade

/** With numbers that a file keeps. */
internal fun Mark.tidied(): Mark {
    val shade = when (val shade = shade) {
        is Shade.Grey -> Shade.Grey(nearestDecimal(shade.reflectance))
        is Shade.Colour -> shade
    }
    val figure = when (val figure = figure) {
        is MarkFigure.Line -> figure.copy(width = rounded(figure.width))
        is MarkFigure.Area, is MarkFigure.GreyMap -> figure
    }
    return copy(shade = shade, figure = figure)
}

internal fun Goal.tidied(): Goal = when (this) {
    is Goal.DrawTemplate -> {
        copy(tolerance = nearestDecimal(tolerance), coverage = nearestDecimal(coverage), excess = nearestDecimal(excess))
    }

    is Goal.InkLength -> {
        copy(atLeast = atLeast?.let(::nearestDecimal), atMost = atMost?.let(::nearestDecimal))
    }

    is Goal.FollowLine -> {
        copy(laps = nearestDecimal(laps), tolerance = nearestDecimal(tolerance))
    }

    is Goal.Reach, is Goal.StayOut, is Goal.StayIn, is Goal.NeverTouch, is Goal.EndWithin, is Goal.ShowOnDisplay, is Goal.PlaySound,
    is Goal.InOrder, is Goal.All, is Goal.AnyOf,
    -> {
        this
    }
}
