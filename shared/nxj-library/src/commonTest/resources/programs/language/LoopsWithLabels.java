public class LoopsWithLabels {
    public static void main(String[] arguments) {
        int found = 0;
        rows:
        for (int row = 1; ; row++) {
            for (int column = 1; column <= row; column++) {
                if (row * column > 40) break rows;
                if ((row + column) % 5 == 0) continue rows;
                found += row * column;
            }
        }
        System.out.println(found); // expect 225
        int count = 0;
        do {
            count += 3;
            if (count == 9) continue;
            if (count > 20) break;
        } while (count < 100);
        System.out.println(count); // expect 21
        block: {
            if (count > 20) break block;
            System.out.println("never");
        }
        for (int i = 0, j = 10; i < j; i++, j -= 2) System.out.println(i + " " + j); // expect 0 10
        // expect 1 8
        // expect 2 6
        // expect 3 4
        int prime = 0;
        for (int n = 2; n < 100; n++) {
            boolean isPrime = true;
            for (int d = 2; d * d <= n; d++) {
                if (n % d == 0) {
                    isPrime = false;
                    break;
                }
            }
            if (isPrime) prime += n;
        }
        System.out.println(prime); // expect 1060
        int collatz = 27;
        int steps = 0;
        while (collatz != 1) {
            collatz = collatz % 2 == 0 ? collatz / 2 : 3 * collatz + 1;
            steps++;
        }
        System.out.println(steps); // expect 111
    }
}
