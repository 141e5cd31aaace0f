import lejos.nxt.LCD;

// button ENTER at 1000: pressed
// button ESCAPE at 1100: pressed
// button ESCAPE at 1300: released
// button ENTER at 1300: released
// screen 0: busy
// ends at 1100
/** ENTER and ESCAPE together end a program that never waits. */
public class Busy {
    public static void main(String[] args) {
        LCD.drawString("busy", 0, 0);
        int rounds = 0;
        while (true) rounds++;
    }
}
