package robotran.microbit.display

import robotran.brick.lights.LightFont

/** The lights of a micro:bit, and what its program prints. */
internal class BoardDisplay {
    private var columns: List<List<Boolean>> = emptyList()
    private var text = ""
    private var began = 0L
    private var now = 0L

    /** What is shown; the same object until it changes. */
    var screen = BoardScreen()
        private set

    /** Returns false if it is not one character that the lights can show. */
    fun show(character: String): Boolean {
        val only = character.singleOrNull()?.takeIf(LightFont::has) ?: return false
        light(brightnesses(LightFont.lightsOf(only)), character)
        return true
    }

    /** Lets a text run over the lights from the right. What cannot be shown is a gap. */
    fun scroll(text: String) {
        light(BoardScreen.DARK, "")
        this.text = text
        columns = text.flatMap(::columnsOf) + List(SIDE) { GAP }
        began = now
        move()
    }

    fun clear() = light(BoardScreen.DARK, "")

    /** Shows a picture of 25 lights that stands for no text. */
    fun draw(lights: List<Boolean>) = light(brightnesses(lights), "")

    fun print(text: String) {
        screen = screen.copy(printed = (screen.printed + text.split('\n')).takeLast(BoardScreen.MOST_PRINTED))
    }

    /** All dark, nothing printed. */
    fun reset() {
        columns = emptyList()
        screen = BoardScreen()
    }

    fun tick(milliseconds: Long) {
        now = milliseconds
        if (columns.isNotEmpty()) move()
    }

    private fun move() {
        val moved = ((now - began) / COLUMN_MILLISECONDS).toInt()
        val isOver = moved >= columns.size
        val lights = if (isOver) BoardScreen.DARK else brightnesses(window(moved))
        val shown = if (isOver) "" else text
        if (screen.lights != lights || screen.shown != shown) screen = screen.copy(lights = lights, shown = shown)
        if (isOver) columns = emptyList()
    }

    /** The lights after [moved] columns; the first one has come in on the right. */
    private fun window(moved: Int): List<Boolean> = List(SIDE * SIDE) { place ->
        val column = moved - (SIDE - 1) + place % SIDE
        columns.getOrNull(column)?.get(place / SIDE) == true
    }

    private fun light(lights: List<Int>, shown: String) {
        columns = emptyList()
        screen = screen.copy(lights = lights, shown = shown)
    }

    private fun columnsOf(character: Char): List<List<Boolean>> {
        if (!LightFont.has(character)) return List(SIDE + 1) { GAP }
        val lights = LightFont.lightsOf(character)
        return List(SIDE) { column -> List(SIDE) { row -> lights[row * SIDE + column] } } + listOf(GAP)
    }

    private fun brightnesses(lights: List<Boolean>) = lights.map { if (it) BoardScreen.BRIGHTEST else 0 }

    companion object {
        /** How long a text stands before it moves on by a column: MicroPython's usual delay. */
        const val COLUMN_MILLISECONDS = 150L

        private const val SIDE = LightFont.SIDE
        private val GAP = List(SIDE) { false }
    }
}
