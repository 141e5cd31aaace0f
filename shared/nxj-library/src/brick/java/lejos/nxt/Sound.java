package lejos.nxt;

import java.io.File;
import lejos.util.Delay;

/** The brick's loudspeaker; one sound at a time, a new one takes the place of the one before. */
public class Sound {
    /** How high the second C is, in hertz. */
    public static final int C2 = 523;

    // An instrument: milliseconds until it is loud, the part of it that is left then in percent, milliseconds until
    // that is so, and milliseconds in which it fades.

    /** Sounds like a piano. */
    public static final int[] PIANO = {4, 60, 60, 60};

    /** Sounds like a flute. */
    public static final int[] FLUTE = {40, 90, 40, 60};

    /** Sounds like a xylophone. */
    public static final int[] XYLOPHONE = {2, 30, 40, 80};

    /** The setting for the volume. */
    public static final String VOL_SETTING = "lejos.volume";

    /** The highest volume. */
    public static final int VOL_MAX = 100;

    private static final int STEP = 10;

    private static int masterVolume = 80;

    private Sound() {
    }

    /** Plays one of the brick's own sounds, 0 to 4; the first value does not matter. */
    public static void systemSound(boolean isQueued, int code) {
        if (code == 0) {
            playTone(600, 200);
        } else if (code == 1) {
            playTone(600, 150);
            pause(200);
            playTone(600, 150);
            pause(150);
        } else if (code == 2) {
            for (int index = 7; index >= 4; index--) playStep(index);
        } else if (code == 3) {
            for (int index = 4; index <= 7; index++) playStep(index);
        } else if (code == 4) {
            playTone(100, 500);
            pause(500);
        }
    }

    /** Beeps once. */
    public static void beep() {
        systemSound(true, 0);
    }

    /** Beeps twice. */
    public static void twoBeeps() {
        systemSound(true, 1);
    }

    /** Plays a row of tones downwards. */
    public static void beepSequence() {
        systemSound(true, 2);
    }

    /** Plays a row of tones upwards. */
    public static void beepSequenceUp() {
        systemSound(true, 3);
    }

    /** Buzzes. */
    public static void buzz() {
        systemSound(true, 4);
    }

    /** Plays a tone of so many hertz for so many milliseconds, and goes on at once. */
    public static void playTone(int frequency, int duration) {
        playTone(frequency, duration, VOL_MAX);
    }

    /** Plays a tone with a volume, 0 to 100; with a minus, the volume that was set does not matter. */
    public static void playTone(int frequency, int duration, int volume) {
        playFreq(frequency, duration, scale(volume));
    }

    /** Plays a tone of an instrument for so many milliseconds, and waits. */
    public static void playNote(int[] instrument, int frequency, int duration) {
        int rise = instrument[0];
        int level = instrument[1];
        int fall = instrument[2];
        int fade = Math.min(instrument[3], duration);
        for (int time = 0; time < duration; time += STEP) {
            int volume = level;
            if (time < rise) {
                volume = 100 * (time + 1) / rise;
            } else if (time < rise + fall) {
                volume = 100 - (100 - level) * (time - rise) / fall;
            }
            if (time >= duration - fade) volume = volume * (duration - time) / fade;
            playTone(frequency, 2 * STEP, volume);
            pause(Math.min(STEP, duration - time));
        }
    }

    /** Plays a sound file; a brick without files gives a number below 0. */
    public static int playSample(File file) {
        return playSample(file, VOL_MAX);
    }

    /** Plays a sound file with a volume, 0 to 100; a brick without files gives a number below 0. */
    public static int playSample(File file, int volume) {
        return file.exists() ? -2 : -1;
    }

    /** Plays bytes as a sound, so many of them a second, and gives how many milliseconds that takes. */
    public static int playSample(byte[] data, int offset, int length, int frequency, int volume) {
        int played = 0;
        while (played < length) {
            int count = playQueuedSample(data, offset + played, length - played, frequency, scale(volume));
            if (count <= 0) pause(1);
            played += count;
        }
        return length * 1000 / frequency;
    }

    /** Waits so many milliseconds. */
    public static void pause(int duration) {
        Delay.msDelay(duration);
    }

    /** Gives how many milliseconds the sound still takes. */
    public static native int getTime();

    /** Sets how loud everything is, 0 to 100. */
    public static void setVolume(int volume) {
        masterVolume = Math.max(0, Math.min(volume, VOL_MAX));
    }

    /** Gives how loud everything is; 80 if nobody sets it. */
    public static int getVolume() {
        return masterVolume;
    }

    private static void playStep(int quarters) {
        playTone(C2 * quarters / 4, 100);
        pause(100);
    }

    private static int scale(int volume) {
        return volume < 0 ? -volume : volume * masterVolume / VOL_MAX;
    }

    private static native void playFreq(int frequency, int duration, int volume);

    private static native int playQueuedSample(byte[] data, int offset, int length, int frequency, int volume);
}
