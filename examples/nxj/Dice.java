// Throws a die a hundred times and shows how often each face came.
// Next: throw two dice and count their sums.

import java.util.ArrayList;
import java.util.Random;
import lejos.nxt.*;

public class Dice {
    public static void main(String[] args) {
        Random random = new Random(7);
        ArrayList<Integer> thrown = new ArrayList<Integer>();
        for (int turn = 0; turn < 100; turn++) thrown.add(random.nextInt(6) + 1);
        for (int face = 1; face <= 6; face++) {
            int count = 0;
            for (int one : thrown) {
                if (one == face) count++;
            }
            LCD.drawString(face + ": " + count, 0, face - 1);
        }
        Button.waitForAnyPress(5000);
    }
}
