package robotran.ui.common.tags

/** The tags of what several rooms have, by which tests and the page find what is on the screen. */
object CommonTags {
    const val KEEPING_TROUBLE = "keeping-trouble"
    const val PLUG_IN = "plug-in"
    const val SEND_ROBOT = "send-robot"
    const val TROUBLE_CLOSE = "trouble-close"
    const val TROUBLE_MY_WORK = "trouble-my-work"
    const val TROUBLE_SAVE_AS = "trouble-save-as"
}
