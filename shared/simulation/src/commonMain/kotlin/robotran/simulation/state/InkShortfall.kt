package robotran.simulation.state

import robotran.world.geometry.Point

/** What was missing for a goal about the drawing, or what was too much. */
sealed interface InkShortfall : GoalShortfall {
    /**
     * Too little was drawn.
     *
     * @property centimetres how much was missing.
     * @property place where the last line ended; null if nothing was drawn.
     */
    data class TooShort(val centimetres: Double, override val place: Point?) : InkShortfall

    /** Too much was drawn, for the first time at [moment]: [centimetres] more than allowed when it was last measured. */
    data class TooLong(val centimetres: Double, override val moment: RunMoment) : InkShortfall

    /**
     * Too little of the template was drawn over.
     *
     * @property share how much of it was drawn over, 0..1.
     * @property wanted how much of it should have been.
     * @property missing the longest stretches that were not, longest first; at most [TemplateStretch.MAX_STRETCHES].
     */
    data class TemplateMissing(val share: Double, val wanted: Double, val missing: List<TemplateStretch>) :
        InkShortfall {
        override val place get() = missing.firstOrNull()?.middle
    }

    /**
     * Too much was drawn beside the template, for the first time at [moment].
     *
     * @property centimetres the length of ink beside it when it was last measured.
     * @property beside the longest stretches of it, longest first; at most [TemplateStretch.MAX_STRETCHES].
     */
    data class InkBesideTemplate(
        val centimetres: Double,
        val beside: List<TemplateStretch>,
        override val moment: RunMoment,
    ) : InkShortfall
}

/**
 * A stretch of a template that was not drawn over, or of ink beside a template.
 *
 * @property points along it, at most [MAX_POINTS].
 */
data class TemplateStretch(val points: List<Point>, val centimetres: Double) {
    val middle: Point get() = points[points.size / 2]

    companion object {
        const val MAX_STRETCHES = 8
        const val MAX_POINTS = 64
    }
}
