// Plays a melody, with a piano at the end.
// Next: play it backward.

import lejos.nxt.*;
import lejos.util.Delay;

public class Melody {
    static final int[] NOTES = { 523, 587, 659, 698, 784, 784 };

    public static void main(String[] args) {
        for (int note : NOTES) {
            Sound.playTone(note, 250);
            Delay.msDelay(300);
        }
        Sound.playNote(Sound.PIANO, 1047, 800);
        Delay.msDelay(800);
    }
}
