package robotran.rcxrom.state

/** What a firmware other than leJOS's knows at one moment; immutable. Each firmware has its own class. */
interface RcxFirmwareState
