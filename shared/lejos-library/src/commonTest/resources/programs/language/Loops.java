import josx.platform.rcx.LCD;

public class Loops {
    public static void main(String[] arguments) {
        int sum = 0;
        for (int number = 1; number <= 10; number++) sum += number;
        LCD.showNumber(sum); // shows: 55
        int times = 0;
        while (sum > 1) {
            sum /= 2;
            times++;
        }
        LCD.showNumber(times); // shows: 5
        do {
            times--;
        } while (times > 10);
        LCD.showNumber(times); // shows: 4
        for (int number = 0; number < 6; number++) {
            if (number == 2) continue;
            if (number == 4) break;
            LCD.showNumber(number); // shows: 0 1 3
        }
        int found = 0;
        rows:
        for (int row = 1; row < 10; row++) {
            for (int column = 1; column < 10; column++) {
                if (column > row) continue rows;
                if (row * column == 42) {
                    found = row;
                    break rows;
                }
            }
        }
        LCD.showNumber(found); // shows: 7
    }
}
