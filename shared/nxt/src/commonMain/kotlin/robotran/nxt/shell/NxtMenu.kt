package robotran.nxt.shell

import robotran.brick.controls.BrickButton
import robotran.nxt.display.DisplayMemory
import robotran.nxt.display.DisplaySize
import robotran.nxt.display.Drawing
import robotran.nxt.sound.NxtSpeaker
import robotran.nxt.state.MenuView
import robotran.nxt.storage.FlashMemory
import robotran.nxt.storage.NxtFile

/** What the shell must do after a key. */
internal sealed interface MenuAction {
    data object None : MenuAction

    data class Start(val slot: Int) : MenuAction

    data object SwitchOff : MenuAction
}

/**
 * The brick's menu: LEFT and RIGHT mark an entry, ENTER takes it, ESCAPE goes back. The words are those of leJOS NXJ.
 *
 * @param programs the names of the programs; null for a slot without a runnable one.
 */
internal class NxtMenu(
    private val name: String,
    private val programs: List<String?>,
    private val settings: MenuSettings,
    private val speaker: NxtSpeaker,
    private val flash: FlashMemory,
    private val millivolts: () -> Int,
) {
    private val pages: ArrayDeque<MenuPage> = ArrayDeque(listOf(MenuPage(name, ::mainEntries)))

    private val page: MenuPage get() = pages.last()

    /** The page that is open. */
    val view: MenuView
        get() {
            val entries = page.entries()
            return MenuView(
                page.title,
                entries.map { it.text },
                if (entries.any { it.action != null }) page.selected else -1,
            )
        }

    /** Goes back to the first page, with its first entry marked. */
    fun reset() {
        while (pages.size > 1) pages.removeLast()
        page.selected = 0
    }

    fun press(button: BrickButton): MenuAction {
        val entries = page.entries()
        when (button) {
            BrickButton.LEFT -> page.selected = (page.selected + entries.size - 1) % entries.size
            BrickButton.RIGHT -> page.selected = (page.selected + 1) % entries.size
            BrickButton.ENTER -> return entries[page.selected].action?.invoke() ?: MenuAction.None
            BrickButton.ESCAPE -> if (pages.size == 1) return MenuAction.SwitchOff else pages.removeLast()
            else -> Unit
        }
        return MenuAction.None
    }

    /** Draws the open page onto a clear display. */
    fun draw(memory: DisplayMemory) {
        val shown = view
        val width = DisplaySize.COLUMNS - VOLTS_WIDTH
        Drawing.drawString(memory, " ${shown.title}".take(width).padEnd(width) + volts(), 0, 0, inverted = true)
        val rows = DisplaySize.ROWS - FIRST_ROW
        val first = maxOf(0, minOf(shown.selected - rows + 1, shown.entries.size - rows))
        shown.entries.drop(first).take(rows).forEachIndexed { row, entry ->
            val text = " $entry".take(DisplaySize.COLUMNS).padEnd(DisplaySize.COLUMNS)
            Drawing.drawString(memory, text, 0, FIRST_ROW + row, inverted = first + row == shown.selected)
        }
    }

    private fun volts(): String {
        val tenths = (millivolts() + HALF_TENTH) / TENTH
        return "${tenths / 10}.${tenths % 10}".padStart(VOLTS_WIDTH)
    }

    private fun mainEntries(): List<MenuEntry> = listOf(
        MenuEntry("Run Default") {
            settings.defaultSlot.let { if (canRun(it)) MenuAction.Start(it) else MenuAction.None }
        },
        opening("Files") { fileEntries() },
        opening("Bluetooth") { listOf(MenuEntry("Name: $name"), MenuEntry("Visible: on")) },
        opening("Sound") { soundEntries() },
        opening("System") { systemEntries() },
        opening("Version") { listOf(MenuEntry("Firmware 0.9.1"), MenuEntry("Menu 0.9.1")) },
    )

    private fun canRun(slot: Int): Boolean = programs.getOrNull(slot) != null

    private fun fileEntries(): List<MenuEntry> {
        val ofPrograms = programs.withIndex().filter { it.value != null }
            .map { (slot, name) -> opening(name.orEmpty()) { programEntries(slot) } }
        val all = ofPrograms + flash.files.map { file -> opening(entryOf(file), file.name) { entriesOf(file) } }
        return all.ifEmpty { listOf(MenuEntry("(no files)")) }
    }

    /** The name of a file and its size behind it, as far as the row has room. */
    private fun entryOf(file: NxtFile): String {
        val size = " ${file.size}"
        val room = DisplaySize.COLUMNS - 1 - size.length
        return file.name.take(room).padEnd(room) + size
    }

    private fun entriesOf(file: NxtFile): List<MenuEntry> = listOf(
        MenuEntry("${file.size} bytes"),
        opening("Delete file", "Delete?") { question(2) { flash.delete(file.name) } },
    )

    /** No, or yes, which does something and closes so many pages. */
    private fun question(pagesToClose: Int, action: () -> Unit): List<MenuEntry> = listOf(
        setting("No") { pages.removeLast() },
        setting("Yes") {
            action()
            repeat(pagesToClose) { pages.removeLast() }
            page.selected = 0
        },
    )

    private fun programEntries(slot: Int): List<MenuEntry> = listOf(
        MenuEntry("Execute program") { MenuAction.Start(slot) },
        setting("Set as Default") {
            settings.defaultSlot = slot
            pages.removeLast()
        },
    )

    private fun soundEntries(): List<MenuEntry> = listOf(
        setting("Volume: ${speaker.setting}") { speaker.setting = (speaker.setting + 1) % LEVELS },
        setting("Key click: ${settings.keyClick}") { settings.keyClick = (settings.keyClick + 1) % LEVELS },
    )

    private fun systemEntries(): List<MenuEntry> = listOf(
        setting("Sleep: ${if (settings.sleepMinutes == 0) "never" else "${settings.sleepMinutes} min"}") {
            settings.sleepMinutes =
                SLEEP_MINUTES[(SLEEP_MINUTES.indexOf(settings.sleepMinutes) + 1) % SLEEP_MINUTES.size]
        },
        setting("Auto Run: ${if (settings.autoRun) "on" else "off"}") { settings.autoRun = !settings.autoRun },
        MenuEntry("Flash: ${flash.freeBytes}"),
        MenuEntry("Free RAM: 48 KB"),
        MenuEntry("Battery:${volts()} V"),
        opening("Format") { question(1) { flash.format() } },
    )

    private fun opening(text: String, title: String = text, entries: () -> List<MenuEntry>): MenuEntry =
        MenuEntry(text) {
            pages += MenuPage(title, entries)
            MenuAction.None
        }

    private fun setting(text: String, change: () -> Unit): MenuEntry = MenuEntry(text) {
        change()
        MenuAction.None
    }

    private class MenuPage(val title: String, val entries: () -> List<MenuEntry>) {
        var selected = 0
    }

    /** @property action null for a line that can only be read. */
    private class MenuEntry(val text: String, val action: (() -> MenuAction)? = null)

    private companion object {
        /** The first row of the entries. */
        const val FIRST_ROW = 2
        const val VOLTS_WIDTH = 5
        const val TENTH = 100
        const val HALF_TENTH = 50
        const val LEVELS = NxtSpeaker.HIGHEST_SETTING + 1
        val SLEEP_MINUTES = listOf(0, 1, 2, 5, 10)
    }
}
