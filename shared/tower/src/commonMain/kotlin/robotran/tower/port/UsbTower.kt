package robotran.tower.port

/** LEGO's USB tower as a USB device. Source: maehw/WebPBrick; nothing was tried on a real tower. */
object UsbTower {
    const val VENDOR = 0x0694
    const val PRODUCT = 0x0001

    /** Of four configurations the one with low power and the normal polling. */
    const val CONFIGURATION = 1
    const val INTERFACE = 0

    /** The bytes in a packet of its two interrupt endpoints. */
    const val PACKET = 8

    /** What to ask a tower that was just opened; its speed is then 2400 baud, its range medium. */
    val START: List<UsbTowerRequest> = listOf(
        // Its version, which is not needed: the tower answers nothing else before.
        UsbTowerRequest(number = 0xFD, value = 0, answerBytes = 8),
        // Reset.
        UsbTowerRequest(number = 0x04, value = 0, answerBytes = 4),
    )

    /** Empties both of its buffers, once its interface is claimed. */
    val FLUSH = UsbTowerRequest(number = 0x03, value = 3, answerBytes = 4)
}

/** A control transfer to the tower: vendor's type, to the device, IN (C0), index 0. */
class UsbTowerRequest(val number: Int, val value: Int, val answerBytes: Int)
