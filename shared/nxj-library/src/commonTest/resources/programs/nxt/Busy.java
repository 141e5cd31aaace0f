import lejos.nxt.Button;
import lejos.nxt.LCD;

/** ENTER and ESCAPE together end a program that never waits. */
public class Busy { // press ENTER at 1000 for 300
    public static void main(String[] args) { // press ESCAPE at 1100 for 200
        LCD.drawString("busy", 0, 0); // screen busy
        int rounds = 0;
        while (true) rounds++; // takes 1100
    }
}
