package robotran.legofirmware.messages

internal object German : FirmwareMessages {
    override val image = ImageGerman
    override val assembly = AssemblyGerman
    override val run = RunGerman
}
