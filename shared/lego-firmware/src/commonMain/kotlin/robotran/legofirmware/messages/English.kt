package robotran.legofirmware.messages

internal object English : FirmwareMessages {
    override val image = ImageEnglish
    override val assembly = AssemblyEnglish
    override val run = RunEnglish
}
