import josx.platform.rcx.MinSound;
import josx.platform.rcx.Sound;

public class Sounds {
    public static void main(String[] arguments) {
        Sound.beep(); // rom: 0x299a 0x4004 0
        Sound.twoBeeps(); // rom: 0x299a 0x4004 1
        Sound.beepSequence(); // rom: 0x299a 0x4004 2
        Sound.buzz(); // rom: 0x299a 0x4004 4
        Sound.systemSound(true, 5); // rom: 0x299a 0x4004 5
        Sound.systemSound(false, 3); // rom: 0x299a 0x4003 3
        Sound.playTone(440, 100); // rom: 0x327c 0x1773 440 100
        Sound.playTone(1000, 300); // rom: 0x327c 0x1773 1000 300
        MinSound.playTone(500, 10); // rom: 0x327c 0x1773 500 10
    }
}
// ends at 0
