import josx.platform.rcx.LCD;

public class Classes {
    static class Account {
        private static int accounts = 0;
        private int balance;
        final int number;

        Account(int balance) {
            this.balance = balance;
            number = ++accounts;
        }

        Account() {
            this(100);
        }

        void pay(int amount) {
            balance += amount;
        }

        int balance() {
            return balance;
        }
    }

    public static void main(String[] arguments) {
        Account mine = new Account();
        Account yours = new Account(5);
        mine.pay(20);
        LCD.showNumber(mine.balance()); // shows: 120
        LCD.showNumber(yours.balance()); // shows: 5
        LCD.showNumber(yours.number); // shows: 2
        LCD.showNumber(Account.accounts); // shows: 2
    }
}
