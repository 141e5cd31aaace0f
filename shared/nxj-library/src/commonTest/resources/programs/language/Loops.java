public class Loops {
    public static void main(String[] arguments) {
        int sum = 0;
        for (int number = 1; number <= 10; number++) sum += number;
        System.out.println(sum); // expect 55
        int times = 0;
        while (sum > 1) {
            sum /= 2;
            times++;
        }
        System.out.println(times); // expect 5
        do {
            times--;
        } while (times > 10);
        System.out.println(times); // expect 4
        for (int number = 0; number < 6; number++) {
            if (number == 2) continue;
            if (number == 4) break;
            System.out.println(number); // expect 0
            // expect 1
            // expect 3
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
        System.out.println(found); // expect 7
    }
}
