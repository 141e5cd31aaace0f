package robotran.rcxrom.messages

import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.messages.PlaceMessages
import robotran.brick.messages.place
import robotran.brick.program.ProgramFailure
import robotran.language.Language
import robotran.rcxrom.call.RomCallText
import robotran.rcxrom.call.RomGap
import robotran.rcxrom.display.LcdIcon
import robotran.rcxrom.infrared.InfraredRange

internal fun hexadecimal(value: Int) = RomCallText.hexadecimal(value)
