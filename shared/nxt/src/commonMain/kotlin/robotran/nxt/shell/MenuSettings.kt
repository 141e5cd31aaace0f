package robotran.nxt.shell

/** What a pupil can set in the menu; it lasts as long as the brick. */
internal class MenuSettings(
    /** Index of the program that Run Default starts. */
    var defaultSlot: Int,
) {
    /** How loud a key is, 0..10. */
    var keyClick = 2

    /** Minutes without a key after which the brick switches itself off; 0 for never. */
    var sleepMinutes = 2

    /** Whether the default program starts by itself when the brick is switched on, unless LEFT is held. */
    var autoRun = false
}
