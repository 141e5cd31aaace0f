package robotran.legofirmware.messages

internal object Spanish : FirmwareMessages {
    override val image = ImageSpanish
    override val assembly = AssemblySpanish
    override val run = RunSpanish
}
