// Throws a die a hundred times, counts each face in an array and
// shows which came most often, and how often.
// Next: throw two and count the sums.

import java.util.Random;
import josx.platform.rcx.LCD;

public class Dice {
    static final int THROWS = 100;

    public static void main(String[] args) throws InterruptedException {
        Random die = new Random();
        int[] counts = new int[7]; // nothing is counted at 0
        for (int times = 0; times < THROWS; times++) {
            int face = 1 + die.nextInt(6);
            counts[face]++;
        }
        int winner = 1;
        for (int face = 2; face <= 6; face++) {
            if (counts[face] > counts[winner]) winner = face;
        }
        LCD.showNumber(winner);
        Thread.sleep(2000);
        LCD.showNumber(counts[winner]);
    }
}
