package robotran.rcxrom.messages

import robotran.rcxrom.call.RomCallText

internal fun hexadecimal(value: Int) = RomCallText.hexadecimal(value)
