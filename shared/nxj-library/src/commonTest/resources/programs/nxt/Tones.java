import lejos.nxt.Sound;

// takes 940
public class Tones {
    public static void main(String[] arguments) {
        Sound.playTone(440, 100); // calls playFreq 440 100 80
        Sound.pause(100);
        Sound.playTone(880, 50, 50); // calls playFreq 880 50 40
        Sound.setVolume(50);
        Sound.beep(); // calls playFreq 600 200 50
        System.out.println(Sound.getVolume() + " " + (Sound.getTime() > 150)); // screen 50 true
        Sound.twoBeeps(); // calls playFreq 600 150 50 | playFreq 600 150 50
        Sound.beepSequenceUp(); // calls playFreq 523 100 50 | playFreq 653 100 50 | playFreq 784 100 50 | playFreq 915 100 50
        Sound.playTone(100, 30, -70); // calls playFreq 100 30 70
        Sound.pause(80);
    }
}
