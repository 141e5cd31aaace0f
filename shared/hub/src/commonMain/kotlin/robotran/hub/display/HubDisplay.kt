package robotran.hub.display

import robotran.hub.model.HubModel

/** The lights and the screen of a hub, and what its program prints. */
internal class HubDisplay(private val model: HubModel) {
    private var text = ""
    private var textBegan = 0L
    private var now = 0L

    /** What is shown; the same object until it changes. */
    var screen = blank()
        private set

    /** Milliseconds until the letters of a text have been shown. */
    val textMillisecondsLeft: Int get() = maxOf(0L, textBegan + text.length * LETTER_MILLISECONDS - now).toInt()

    fun showNumber(number: Int) = light(MatrixFont.lightsOf(number), number.toString())

    /** Returns false if it is not one character that the lights can show. */
    fun showCharacter(character: String): Boolean {
        val only = character.singleOrNull()?.takeIf(MatrixFont::has) ?: return false
        light(MatrixFont.lightsOf(only), character)
        return true
    }

    /** Shows the letters one after another. Returns false, once it is there, at one that the lights cannot show. */
    fun showText(text: String): Boolean {
        light(MatrixFont.DARK, "")
        this.text = text.takeWhile(MatrixFont::has)
        textBegan = now
        showLetter()
        return this.text.length == text.length
    }

    fun lightsOff() = light(MatrixFont.DARK, "")

    /** Writes a row below the others; the upper ones move out. */
    fun printRow(text: String) {
        val filled = screen.rows.dropLastWhile { it.isEmpty() }
        val rows = (filled + text.split('\n').map { it.take(model.columns) }).takeLast(model.rows)
        screen = screen.copy(rows = rows + List(model.rows - rows.size) { "" })
    }

    fun clearRows() {
        screen = screen.copy(rows = List(model.rows) { "" })
    }

    /** Shows the hub's own rows. */
    fun showRows(rows: List<String>) {
        screen = screen.copy(rows = List(model.rows) { rows.getOrElse(it) { "" }.take(model.columns) })
    }

    fun print(text: String) {
        screen = screen.copy(printed = (screen.printed + text.split('\n')).takeLast(HubScreen.MOST_PRINTED))
    }

    /** All dark, nothing printed. */
    fun clear() {
        text = ""
        screen = blank()
    }

    fun tick(milliseconds: Long) {
        now = milliseconds
        if (text.isNotEmpty()) showLetter()
    }

    private fun showLetter() {
        val passed = now - textBegan
        val number = (passed / LETTER_MILLISECONDS).toInt()
        val letter = text.getOrNull(number)
        val isOn = letter != null && passed % LETTER_MILLISECONDS < ON_MILLISECONDS
        val lights = if (isOn) MatrixFont.lightsOf(checkNotNull(letter)) else MatrixFont.DARK
        // The whole text is what is shown, until its last letter has gone.
        val shown = if (letter == null) "" else text
        if (screen.lights != lights || screen.shown != shown) screen = screen.copy(lights = lights, shown = shown)
        if (letter == null) text = ""
    }

    private fun light(lights: List<Int>, shown: String) {
        text = ""
        screen = screen.copy(lights = lights, shown = shown)
    }

    private fun blank() = HubScreen(
        lights = if (model.hasMatrix) MatrixFont.DARK else emptyList(),
        rows = List(model.rows) { "" },
    )

    companion object {
        /** How long each letter of a text takes. */
        const val LETTER_MILLISECONDS = 550L

        private const val ON_MILLISECONDS = 500L
    }
}
