import lejos.nxt.*;

public class Hal extends Thread {
    public static void main(String[] args) {
        while (true) {
            new Hal().start();
        }
    }

    public void run() {
        while (true) {
            Sound.playTone(440, 1);
            LCD.drawString("again and again", 0, 0);
        }
    }
}
