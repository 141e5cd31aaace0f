package robotran.legofirmware.messages

internal object Spanish : FirmwareMessages {
    override val image = ImageSpanish
}
