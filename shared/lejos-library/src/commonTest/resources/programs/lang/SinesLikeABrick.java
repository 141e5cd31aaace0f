import josx.platform.rcx.LCD;

public class SinesLikeABrick {
    static int largestError() {
        int largest = 0;
        for (int quarters = -8; quarters <= 8; quarters++) {
            double angle = quarters * Math.PI / 2;
            largest = Math.max(largest, (int) (Math.abs(Math.sin(angle) - ((quarters & 1) == 0 ? 0 : 2 - (quarters & 3))) * 1000000));
            largest = Math.max(largest, (int) (Math.abs(Math.cos(angle) - ((quarters & 1) == 1 ? 0 : 1 - (quarters & 3))) * 1000000));
        }
        return largest;
    }

    public static void main(String[] arguments) {
        LCD.showNumber((int) (Math.sin(Math.PI / 6) * 100)); // shows: 49
        LCD.showNumber(-(int) (Math.sin(-Math.PI / 6) * 100)); // shows: 49
        LCD.showNumber((int) (Math.sin(Math.PI / 2) * 100)); // shows: 99
        LCD.showNumber((int) (Math.cos(Math.PI / 3) * 1000)); // shows: 499
        LCD.showNumber(largestError() < 10 ? 1 : 0); // shows: 1
    }
}
