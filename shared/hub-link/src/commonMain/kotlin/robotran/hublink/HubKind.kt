package robotran.hublink

/**
 * A hub that runs Pybricks, as its PnP id tells it.
 *
 * @property productName as it stands on the box.
 * @property usbProduct its product number below LEGO's vendor number on USB; null if no program goes over its USB.
 * @property hasBluetooth whether programs go over Bluetooth.
 */
enum class HubKind(val productName: String, val usbProduct: Int? = null, val hasBluetooth: Boolean = true) {
    SPIKE_PRIME("SPIKE Prime", usbProduct = 0x0009),
    ROBOT_INVENTOR("Robot Inventor", usbProduct = 0x0010),
    SPIKE_ESSENTIAL("SPIKE Essential", usbProduct = 0x000D),
    TECHNIC("Technic Hub"),
    CITY("City Hub"),
    MOVE("BOOST Move Hub"),
    EV3("EV3", usbProduct = 0x0005, hasBluetooth = false),
    NXT("NXT", usbProduct = 0x0002, hasBluetooth = false),

    /** A newer hub than we know. */
    UNKNOWN("Pybricks"),
    ;

    companion object {
        /** LEGO's vendor number on USB. */
        const val USB_VENDOR = 0x0694

        /** The hub with the product number [product] of USB; null if there is none. */
        fun ofUsbProduct(product: Int): HubKind? = entries.firstOrNull { it.usbProduct == product }

        /** The hub of a PnP [id], 7 bytes: whose number, vendor, kind and variant. */
        fun ofPnpId(id: ByteArray): HubKind {
            if (id.size < PNP_ID_SIZE) return UNKNOWN
            return when (id.u16(KIND_PLACE)) {
                0x40 -> MOVE
                0x41 -> CITY
                0x80 -> TECHNIC
                0x81 -> if (id.u16(VARIANT_PLACE) == INVENTOR_VARIANT) ROBOT_INVENTOR else SPIKE_PRIME
                0x83 -> SPIKE_ESSENTIAL
                0xE1 -> NXT
                0xE2 -> EV3
                else -> UNKNOWN
            }
        }

        private const val PNP_ID_SIZE = 7
        private const val KIND_PLACE = 3
        private const val VARIANT_PLACE = 5
        private const val INVENTOR_VARIANT = 1
    }
}
